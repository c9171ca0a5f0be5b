// The before/after sliders. The range input is the control for keys and assistive technology; a pointer may drag the
// picture itself. Without this script the page shows the chapters' own pictures only.
"use strict";
document.documentElement.classList.add("js");

for (const compare of document.querySelectorAll(".compare")) {
  const frame = compare.querySelector(".frame");
  const range = compare.querySelector("input");

  const show = (percent) => {
    frame.style.setProperty("--split", percent + "%");
    range.setAttribute("aria-valuetext", `${Math.round(percent)} % of ${compare.dataset.before}`);
  };
  range.addEventListener("input", () => show(range.valueAsNumber));

  const drag = (event) => {
    const box = frame.getBoundingClientRect();
    const percent = Math.min(100, Math.max(0, (100 * (event.clientX - box.left)) / box.width));
    range.value = percent;
    show(percent);
  };
  frame.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    frame.setPointerCapture(event.pointerId);
    range.focus({ preventScroll: true });
    drag(event);
  });
  frame.addEventListener("pointermove", (event) => {
    if (frame.hasPointerCapture(event.pointerId)) drag(event);
  });

  range.value = 20;
  show(20);
}
