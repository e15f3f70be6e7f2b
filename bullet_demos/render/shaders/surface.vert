layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 colour;
layout(location = 3) in float inside;
uniform mat4 model, view_projection, to_shadow;
out vec3 local, world, world_normal, vertex_colour, shadow_place;
out float is_inside;

void main() {
    vec4 at = model * vec4(position, 1.0);
    local = position;
    world = at.xyz;
    world_normal = mat3(model) * normal;
    vertex_colour = colour;
    is_inside = inside;
    shadow_place = (to_shadow * at).xyz * 0.5 + 0.5;
    gl_Position = view_projection * at;
}
