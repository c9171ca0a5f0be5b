// Rasterisation: each corner of a triangle to its place on the screen, of the eye or of a lamp.
uniform samplerBuffer corners, normals; // one for each point of the mesh
uniform mat4 to_screen;

out vec3 point, normal;

void main() {
    point = texelFetch(corners, gl_VertexID).xyz;
    normal = texelFetch(normals, gl_VertexID).xyz;
    gl_Position = to_screen * vec4(point, 1);
}
