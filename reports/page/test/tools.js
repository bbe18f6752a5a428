// What every script of this folder begins with.
const saw = {};
addEventListener("error", (event) => {
  saw.error = event.message;
});

const all = (selector) => [...document.querySelectorAll(selector)];
const frame = () => new Promise(requestAnimationFrame);
/** Plots follow their frame's width, and are drawn in the frame after the one in which it is known. */
const settled = async () => {
  for (let i = 0; i < 3; ++i) await frame();
};
