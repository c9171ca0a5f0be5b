// The before/after sliders, and the bar of parts. The range input is the control for keys and assistive technology; a pointer may drag the
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

// The bar of parts says which part is in sight: the last one that begins above a quarter of the window.
const parts = [...document.querySelectorAll(".parts a")].map((link) => [link, document.getElementById(link.hash.slice(1))]);
const mark = () => {
  const atEnd = window.innerHeight + window.scrollY >= document.documentElement.scrollHeight - 2;
  const begun = parts.filter(([, part]) => atEnd || part.getBoundingClientRect().top <= window.innerHeight / 4);
  for (const [link] of parts) link.removeAttribute("aria-current");
  if (begun.length) begun.at(-1)[0].setAttribute("aria-current", "true");
};
for (const event of ["scroll", "resize"]) window.addEventListener(event, () => requestAnimationFrame(mark), { passive: true });
mark();
