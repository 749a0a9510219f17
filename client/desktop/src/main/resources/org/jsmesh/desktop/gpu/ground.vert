#version 330 core
// A square below the model, in unit space.
uniform mat4 view;
uniform mat4 projection;
uniform float extent;
uniform float height;

out vec2 place;

void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2 - 1;
    place = .5 + .5 * corner;
    gl_Position = projection * (view * vec4(extent * corner.x, height, extent * corner.y, 1));
}
