// From light to the colours of a screen: bright parts are bent towards white (K. Narkowicz, ACES filmic curve, 2016).
in vec2 place;
out vec4 shown;
uniform sampler2D light_map;

void main() {
    vec3 x = 0.82 * texture(light_map, place).rgb;
    vec3 bent = clamp((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
    vec2 off = place - 0.5;
    shown = vec4(pow(bent * (1.0 - 0.35 * dot(off, off)), vec3(1.0 / 2.2)), 1.0);
}
