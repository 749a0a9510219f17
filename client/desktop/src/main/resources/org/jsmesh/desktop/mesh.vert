#version 330 core
// From unit space to the screen; light is computed per fragment in eye space.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 texCoord;
layout(location = 3) in vec3 colour;

uniform mat4 view;
uniform mat4 projection;
uniform bool imageFromTop;

out vec3 eyePosition;
out vec3 eyeNormal;
out vec2 imagePosition;
out vec3 linearColour;

vec3 toLinear(vec3 s) {
    return mix(s / 12.92, pow((s + .055) / 1.055, vec3(2.4)), greaterThan(s, vec3(.04045)));
}

void main() {
    vec4 eye = view * vec4(position, 1);
    eyePosition = eye.xyz;
    eyeNormal = mat3(view) * normal;
    imagePosition = imageFromTop ? texCoord : vec2(texCoord.x, 1 - texCoord.y);
    linearColour = toLinear(colour);
    gl_Position = projection * eye;
}
