"use strict";
// Plays the frames: a click or the space bar starts and stops, the slider and the arrow keys choose a frame.
(() => {
  for (const store of document.querySelectorAll("script.frames")) {
    const data = JSON.parse(store.textContent), figure = store.closest("figure"), image = figure.querySelector("img");
    const bar = figure.insertBefore(document.createElement("div"), store); bar.className = "controls";
    bar.innerHTML = `<button type="button"></button><input type="range" min="0" max="${data.frames.length - 1}" value="0" step="1" aria-label="frame"><select aria-label="speed"><option value="24">24 a second<option value="12" selected>12 a second<option value="4">4 a second</select><output></output>`;
    const [button, range, speed, said] = bar.children; let timer = 0, now = 0;
    const show = k => { now = (k + data.frames.length) % data.frames.length; image.src = data.frames[now]; range.value = now; said.textContent = data.labels[now]; };
    const stop = () => { clearInterval(timer); timer = 0; button.textContent = "play"; };
    const play = () => { clearInterval(timer); timer = setInterval(() => show(now + 1), 1000 / Number(speed.value)); button.textContent = "stop"; };
    const turn = () => timer ? stop() : play();
    button.onclick = turn; image.onclick = turn; speed.onchange = () => { if (timer) play(); };
    range.oninput = () => { stop(); show(Number(range.value)); };
    document.addEventListener("keydown", e => {
      if (e.target !== document.body) return;
      if (e.key === " ") turn(); else if (e.key === "ArrowRight") { stop(); show(now + 1); } else if (e.key === "ArrowLeft") { stop(); show(now - 1); } else return;
      e.preventDefault();
    });
    show(0); matchMedia("(prefers-reduced-motion: reduce)").matches ? stop() : play();
  }
})();
