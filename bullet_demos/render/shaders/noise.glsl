// Value noise and sums of it, from 0 to 1.
float hash(vec3 p) {
    p = fract(p * vec3(0.1031, 0.1030, 0.0973));
    p += dot(p, p.yxz + 33.33);
    return fract((p.x + p.y) * p.z);
}

float noise(vec3 p) {
    vec3 cell = floor(p), f = fract(p);
    f = f * f * (3.0 - 2.0 * f);
    vec2 o = vec2(0.0, 1.0);
    vec4 low = vec4(hash(cell), hash(cell + o.yxx), hash(cell + o.xyx), hash(cell + o.yyx));
    vec4 high = vec4(hash(cell + o.xxy), hash(cell + o.yxy), hash(cell + o.xyy), hash(cell + o.yyy));
    vec4 level = mix(low, high, f.z);
    vec2 line = mix(level.xz, level.yw, f.x);
    return mix(line.x, line.y, f.y);
}

float clouds(vec3 p) {
    return 0.5 * noise(p) + 0.3 * noise(2.03 * p + 7.1) + 0.2 * noise(4.07 * p + 3.7);
}
