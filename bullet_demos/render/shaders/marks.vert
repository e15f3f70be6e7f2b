// Points and lines in plain colours.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 colour;
layout(location = 2) in float radius;
uniform mat4 view_projection;
uniform float pixels_at_one_metre;
out vec3 mark_colour;

void main() {
    gl_Position = view_projection * vec4(position, 1.0);
    gl_PointSize = clamp(2.0 * radius * pixels_at_one_metre / gl_Position.w, 2.0, 64.0);
    mark_colour = colour;
}
