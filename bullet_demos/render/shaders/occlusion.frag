// Corners get less of the sky: the share of points around a place that lie before the surface.
in vec2 place;
out vec4 shown;
uniform sampler2D depth_map;
uniform mat4 from_projection;  // clip space to the eye's coordinates
uniform vec2 radius;           // of the neighbourhood at a distance of 1 m, as a fraction of the picture
uniform float reach;           // m

vec3 seen(vec2 anywhere) {
    vec2 at = clamp(anywhere, vec2(0.002), vec2(0.998));
    vec4 p = from_projection * vec4(vec3(at, texture(depth_map, at).r) * 2.0 - 1.0, 1.0);
    return p.xyz / p.w;
}

void main() {
    if (texture(depth_map, place).r >= 1.0) {
        shown = vec4(1.0);
        return;
    }
    vec3 here = seen(place);
    vec3 normal = normalize(cross(dFdx(here), dFdy(here)));
    float turn = 6.28318 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    const int points = 14;
    float hidden = 0.0;
    for (int i = 0; i < points; ++i) {
        float out_to = (float(i) + 0.5) / float(points), angle = turn + 2.39996 * float(i);
        vec3 other = seen(place + out_to * radius * vec2(cos(angle), sin(angle)) / -here.z) - here;
        float distance_m = length(other);
        hidden += max(dot(other, normal) - 0.02 * reach, 0.0) / (distance_m + 1e-5) * smoothstep(1.6 * reach, 0.6 * reach, distance_m);
    }
    shown = vec4(vec3(clamp(1.0 - 1.5 * hidden / float(points), 0.25, 1.0)), 1.0);
}
