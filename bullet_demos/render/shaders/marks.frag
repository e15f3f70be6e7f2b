in vec3 mark_colour;
in float mark_opacity;
out vec4 shown;
uniform bool round, soft;

void main() {
    float light = 1.0;
    if (round) {
        vec2 at = gl_PointCoord * 2.0 - 1.0;
        float out_to = dot(at, at);
        if (out_to > 1.0) discard;
        if (soft) {
            shown = vec4(mark_colour, mark_opacity * (1.0 - out_to) * (1.0 - out_to));
            return;
        }
        light = 0.45 + 0.55 * dot(vec3(at.x, -at.y, sqrt(1.0 - out_to)), normalize(vec3(-0.4, 0.6, 0.7)));
    }
    shown = vec4(light * mark_colour, 1.0);
}
