// Whitted's recursion without recursion (A 2.4): at glass, the refracted ray waits on a stack while the mirrored one is
// followed; when a path ends, the last one that waits goes on. Each ray carries its share of the pixel's light.
uniform int most_bounces;
uniform float least_weight;

float rays_not_kept = 0; // that found the stack full

#ifdef HAS_GLASS
// Used in place: an array that is handed to a function is copied, all of it, each time.
vec4 stack_origin[STACK_SIZE], stack_direction[STACK_SIZE]; // and, in w, t of nothing and the bounces
vec3 stack_weight[STACK_SIZE];
#endif

float largest(vec3 c) { return max(max(c.r, c.g), c.b); }

bool worth_following(vec3 weight, int bounces) { return bounces <= most_bounces && largest(weight) >= least_weight; }

vec3 trace(Ray ray) {
    vec3 sum = vec3(0), weight = vec3(1);
    int bounces = 0, waiting = 0;
    bool ended = false;
    for (int rays = 0; rays < MOST_RAYS && !ended; ++rays) {
        Hit hit = closest_hit(ray);
        bool goes_on = false;
        if (hit.kind == NOTHING) {
            sum += weight * sky_radiance(ray.direction);
        } else {
            Surface surface = surface_of(ray, hit);
            int material = surface.material;
            bool from_behind = dot(surface.normal, ray.direction) > 0;
            vec3 normal = from_behind ? -surface.shading_normal : surface.shading_normal;

#ifdef HAS_GLOW
            sum += weight * coefficient(material, GLOW, surface.uv);
#endif
#ifdef HAS_FACING
            vec3 colour = coefficient(material, FACING, surface.uv);
            if (colour != vec3(0)) {
                float cosine = abs(dot(surface.normal, normalize(ray.direction)));
                sum += weight * mix(sky_radiance(ray.direction), colour, cosine * sqrt(cosine));
            }
#endif
#ifdef HAS_DIFFUSE
            vec3 diffuse = coefficient(material, DIFFUSE, surface.uv);
            if (diffuse != vec3(0)) {
                vec3 light = direct_light(surface, normal);
#ifdef SKY_STUDIO
                light += ambient(normal);
#endif
                sum += weight * diffuse * light;
            }
#endif
#if defined(HAS_MIRROR) || defined(HAS_GLASS)
            vec3 reflection = coefficient(material, REFLECTION, surface.uv), direction = ray.direction;
            ++bounces;
#ifdef HAS_GLASS
            vec3 transmission = coefficient(material, TRANSMISSION, surface.uv);
            if (transmission != vec3(0)) {
                vec4 inside = texelFetch(scene, material + MEDIA), outside = texelFetch(scene, material + MEDIA + 1);
                vec4 behind = from_behind ? inside : outside, ahead = from_behind ? outside : inside;
#ifdef HAS_ABSORPTION
                weight *= exp(-distance(surface.point, ray.origin) * behind.rgb);
#endif
                direction = normalize(direction);
                vec2 shares = fresnel(min(abs(dot(direction, surface.normal)), 1), behind.w, ahead.w);
                vec3 passed = weight * shares.y * transmission;
                reflection *= shares.x;
                if (shares.y > 0 && worth_following(passed, bounces)) {
                    if (waiting < STACK_SIZE) {
                        Ray refracted = spawn_ray(
                            surface, refracted_direction(direction, surface.normal, behind.w, ahead.w), infinity);
                        stack_origin[waiting] = vec4(refracted.origin, 0);
                        stack_direction[waiting] = vec4(refracted.direction, bounces);
                        stack_weight[waiting] = passed;
                        ++waiting;
                    } else
                        ++rays_not_kept;
                }
            }
#endif
            weight *= reflection;
            if (reflection != vec3(0) && worth_following(weight, bounces)) {
                ray = spawn_ray(surface, mirror_direction(direction, surface.normal), infinity);
                goes_on = true;
            }
#endif
        }
        if (!goes_on) {
            ended = waiting == 0;
#ifdef HAS_GLASS
            if (!ended) {
                --waiting;
                ray = Ray(stack_origin[waiting].xyz, stack_direction[waiting].xyz, infinity);
                bounces = int(stack_direction[waiting].w);
                weight = stack_weight[waiting];
            }
#endif
        }
    }
    if (!ended)
        out_of_steps = true;
    return sum;
}
