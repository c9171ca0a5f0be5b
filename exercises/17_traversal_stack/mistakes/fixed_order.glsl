// Mistake: the second child is always visited first.
// Caught by: the nearer child is visited first
float nearest() {
    float best = -1;
    int waiting[DEPTH];
    int count = 0;
    if (enters(0) >= 0) {
        waiting[0] = 0;
        count = 1;
    }
    while (count > 0) {
        --count;
        int node = waiting[count];
        if (is_leaf(node)) {
            float t = hit(node);
            if (t >= 0) {
                best = t;
                t_max = t;
            }
            continue;
        }
        int first = first_child(node), second = second_child(node);
        float enter_first = enters(first), enter_second = enters(second);
        if (enter_first >= 0 && enter_second >= 0) {
            bool swapped = true;
            waiting[count] = swapped ? first : second;
            waiting[count + 1] = swapped ? second : first;
            count += 2;
        } else if (enter_first >= 0) {
            waiting[count] = first;
            ++count;
        } else if (enter_second >= 0) {
            waiting[count] = second;
            ++count;
        }
    }
    return best;
}
