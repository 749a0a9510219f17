#version 330 core
in float height;

uniform vec3 bottom;
uniform vec3 top;

out vec4 colour;

void main() {
    colour = vec4(mix(bottom, top, height), 1);
}
