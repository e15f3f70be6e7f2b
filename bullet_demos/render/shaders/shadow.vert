layout(location = 0) in vec3 position;
uniform mat4 model, to_shadow;

void main() {
    gl_Position = to_shadow * model * vec4(position, 1.0);
}
