// Note A 3.2.2: the constants of every triangle's test, worked out by the GPU, one triangle for each vertex. Nothing is
// drawn; the outputs are caught in the buffer that the tracer reads (transform feedback).
uniform samplerBuffer corners; // three for each triangle; the first one's w is the material

out vec4 corner, normal, k1, k2;

void main() {
    corner = texelFetch(corners, 3 * gl_VertexID);
    // In double, since it is done but once: in float a needle's constants would keep few right digits.
    dvec3 e1 = dvec3(texelFetch(corners, 3 * gl_VertexID + 1).xyz) - dvec3(corner.xyz);
    dvec3 e2 = dvec3(texelFetch(corners, 3 * gl_VertexID + 2).xyz) - dvec3(corner.xyz);
    dvec3 area = cross(e1, e2);
    double area_squared = dot(area, area); // A eq. 21
    normal = vec4(normalize(area), 0);
    k1 = vec4(cross(e2, area) / area_squared, 0); // A eq. 20, with the cross product for its differences
    k2 = vec4(cross(area, e1) / area_squared, 0);
    gl_Position = vec4(0);
}
