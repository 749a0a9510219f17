#version 330 core
// One triangle over the whole window.
out vec2 place;

void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1);
    place = vec2(.5 + .5 * corner.x, .5 - .5 * corner.y);
    gl_Position = vec4(corner, 0, 1);
}
