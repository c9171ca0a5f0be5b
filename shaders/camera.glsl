// The pinhole camera (chapter 01): a place in the picture, in pixels from the top left corner, to a ray.
uniform vec3 camera_eye, camera_top_left, camera_across, camera_down;

Ray camera_ray(vec2 place) {
    return Ray(camera_eye, camera_top_left + place.x * camera_across + place.y * camera_down, infinity);
}
