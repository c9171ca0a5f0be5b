// Nothing but the headers that every grading test includes.
