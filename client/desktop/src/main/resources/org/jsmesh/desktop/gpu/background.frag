#version 330 core
// A light spot on grey, as org.jsmesh.studio.Ground has it.
in vec2 place;

uniform vec3 middle;
uniform vec3 corner;
// Of the spot, from the left and from the upper edge.
uniform vec2 spot;

out vec4 colour;

void main() {
    vec2 away = (place - spot) / max(spot, 1 - spot);
    colour = vec4(mix(middle, corner, min(1, length(away) / sqrt(2.))), 1);
}
