in vec2 place;
out vec4 shown;
uniform mat4 from_clip;
#include "environment.glsl"

void main() {
    vec4 near = from_clip * vec4(place * 2.0 - 1.0, -1.0, 1.0), far = from_clip * vec4(place * 2.0 - 1.0, 1.0, 1.0);
    shown = vec4(background(normalize(far.xyz / far.w - near.xyz / near.w)), 1.0);
}
