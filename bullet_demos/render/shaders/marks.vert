// Points and lines in plain colours.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 colour;
layout(location = 2) in float radius;
layout(location = 3) in float opacity;
uniform mat4 view_projection;
uniform float pixels_at_one_metre, largest_pixels;
out vec3 mark_colour;
out float mark_opacity;

void main() {
    gl_Position = view_projection * vec4(position, 1.0);
    gl_PointSize = clamp(2.0 * radius * pixels_at_one_metre / gl_Position.w, 2.0, largest_pixels);
    mark_colour = colour;
    mark_opacity = opacity;
}
