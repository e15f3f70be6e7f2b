// A studio: sky, horizon, ground, and two soft boxes that a glaze mirrors.
uniform vec3 sky_colour, horizon_colour, ground_colour;
uniform vec3 sun_colour, to_sun;

vec3 background(vec3 direction) {
    float up = direction.z;
    vec3 above = mix(horizon_colour, sky_colour, smoothstep(0.0, 0.8, up));
    return mix(above, ground_colour, smoothstep(0.0, 0.5, -up));
}

float softBox(vec3 direction, vec3 centre, vec2 half_size, float blur) {
    vec3 right = normalize(cross(centre, vec3(0, 0, 1))), top = cross(right, centre);
    float depth = dot(direction, centre);
    if (depth <= 0.05) return 0.0;
    vec2 at = abs(vec2(dot(direction, right), dot(direction, top))) / depth;
    vec2 edge = smoothstep(half_size + blur, half_size - blur, at);
    return edge.x * edge.y;
}

vec3 mirrored(vec3 direction, float roughness) {
    float blur = 0.03 + roughness;
    vec3 light = background(direction);
    light += 4.0 * sun_colour * softBox(direction, to_sun, vec2(0.42, 0.26), blur) / (1.0 + 4.0 * roughness);
    vec3 other = normalize(vec3(-to_sun.x, -to_sun.y, 0.55) + vec3(0.5, -0.3, 0.0));
    return light + 1.3 * sky_colour * softBox(direction, other, vec2(0.16, 0.7), blur);
}

vec3 ambient(vec3 normal) {
    vec3 level = mix(horizon_colour, ground_colour, 0.25);
    return normal.z > 0.0 ? mix(level, sky_colour, normal.z) : mix(level, ground_colour, -normal.z);
}
