// What is drawn over a plain colour. `local` is in the coordinates of the mesh, so that pieces go on with the pattern of the whole.
uniform int pattern;  // render::Pattern
uniform float pattern_size;
uniform vec3 grain;

const int plaster_pattern = 1, wood_pattern = 2, stone_pattern = 3, speckle_pattern = 4;

vec3 woodColour(vec3 base, vec3 p) {
    vec3 axis = normalize(grain);
    vec3 side = normalize(abs(axis.z) < 0.9 ? cross(axis, vec3(0, 0, 1)) : vec3(1, 0, 0));
    vec3 across = vec3(dot(p, side), dot(p, cross(axis, side)), dot(p, axis));
    vec3 bent = across + 0.35 * (clouds(across * vec3(0.8, 0.8, 0.25)) - 0.5);
    float radius = length(bent.xy - vec2(1.3, 4.2)) * 5.0;
    float ring = fract(radius), late = smoothstep(0.35, 0.95, ring) * smoothstep(1.0, 0.96, ring);
    float fibre = clouds(across * vec3(45.0, 45.0, 1.6));
    return base * (1.16 - 0.5 * late) * (0.78 + 0.42 * fibre);
}

vec3 patterned(vec3 base, vec3 p, float inside) {
    vec3 q = p / pattern_size;
    if (pattern == plaster_pattern) return base * (0.90 + 0.2 * clouds(q * 1.7)) * (0.95 + 0.1 * noise(q * 60.0));
    if (pattern == wood_pattern) return woodColour(base, q);
    if (pattern == stone_pattern) {
        float cloud = clouds(q * 0.6), fine = noise(q * 38.0) * 0.6 + noise(q * 90.0) * 0.4;
        return base * (0.88 + 0.22 * cloud) * (0.93 + 0.14 * fine);
    }
    if (pattern == speckle_pattern && inside < 0.5) {
        float spot = smoothstep(0.84, 0.9, noise(q * 48.0)) * smoothstep(0.4, 0.6, noise(q * 11.0 + 5.0));
        return base * (0.95 + 0.1 * clouds(q * 2.0)) * (1.0 - 0.55 * spot);
    }
    return base;
}

// How rough a surface is: a bump's height and its width as a fraction of the pattern.
vec2 bump(float inside) {
    if (pattern == plaster_pattern) return vec2(inside > 0.5 ? 0.30 : 0.16, inside > 0.5 ? 0.03 : 0.009);
    if (pattern == wood_pattern) return vec2(inside > 0.5 ? 0.25 : 0.05, 0.02);
    if (pattern == stone_pattern) return vec2(0.05, 0.03);
    return inside > 0.5 ? vec2(0.28, 0.05) : vec2(0.0, 1.0);
}

vec3 bumped(vec3 normal, vec3 p, float inside, float distance_m) {
    vec2 size = bump(inside);
    float width = size.y * pattern_size;
    float fade = size.x * clamp(1.2 - distance_m / (900.0 * width), 0.0, 1.0);
    if (fade <= 0.0) return normal;
    vec3 q = p / width;
    if (pattern == wood_pattern) q -= 0.96 * dot(q, normalize(grain)) * normalize(grain);
    float here = noise(q);
    vec3 slope = vec3(noise(q + vec3(0.4, 0, 0)), noise(q + vec3(0, 0.4, 0)), noise(q + vec3(0, 0, 0.4))) - here;
    return normalize(normal - 2.5 * fade * slope);
}
