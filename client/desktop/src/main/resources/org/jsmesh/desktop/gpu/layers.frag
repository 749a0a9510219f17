#version 330 core
// What all layers together show, premultiplied.
in vec2 place;

uniform sampler2D layers;

out vec4 colour;

void main() {
    colour = texture(layers, vec2(place.x, 1 - place.y));
}
