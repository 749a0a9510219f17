#version 330 core
// Keeps light from what is behind.
in vec2 place;

uniform sampler2D shadow;
uniform float darkest;

out vec4 colour;

void main() {
    colour = vec4(0, 0, 0, darkest * texture(shadow, place).r);
}
