#version 330 core
// From unit space to the screen; light is computed per fragment in eye space.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 colour;
layout(location = 3) in vec4 tangent;
layout(location = 4) in vec2 set0;
layout(location = 5) in vec2 set1;
layout(location = 6) in vec2 set2;
layout(location = 7) in vec2 set3;
layout(location = 8) in vec4 start;
layout(location = 9) in float distance;

const int SLOTS = 8;

uniform mat4 view;
uniform mat4 projection;
// Of each slot: the set of texture coordinates, and two rows that turn (u, v, 1) into a place on the image.
uniform int sets[SLOTS];
uniform vec3 rows[2 * SLOTS];
// The step of which only a part has arrived; its vertices stay where they start.
uniform float step;

// Depths of the same vertex are compared, which several programs reckon.
invariant gl_Position;
out vec3 eyePosition;
out vec3 eyeNormal;
out vec4 eyeTangent;
out vec4 linearColour;
out vec2 places[SLOTS];
out float error;

vec3 toLinear(vec3 s) {
    return mix(s / 12.92, pow((s + .055) / 1.055, vec3(2.4)), greaterThan(s, vec3(.04045)));
}

void main() {
    vec4 eye = view * vec4(start.w == step ? start.xyz : position, 1);
    error = distance;
    eyePosition = eye.xyz;
    eyeNormal = mat3(view) * normal;
    eyeTangent = vec4(mat3(view) * tangent.xyz, tangent.w);
    linearColour = vec4(toLinear(colour.rgb), colour.a);
    for (int i = 0; i < SLOTS; i++) {
        vec2 uv = sets[i] == 0 ? set0 : sets[i] == 1 ? set1 : sets[i] == 2 ? set2 : set3;
        places[i] = vec2(dot(rows[2 * i], vec3(uv, 1)), dot(rows[2 * i + 1], vec3(uv, 1)));
    }
    gl_Position = projection * eye;
}
