// Mistake: only the nearer child is visited, and the farther one is never put on the stack.
// Caught by: the nearest hit is found, the same as by asking every sphere
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
            bool swapped = enter_second < enter_first;
            waiting[count] = swapped ? second : first;
            ++count;
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
