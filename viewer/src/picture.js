// SPDX-License-Identifier: GPL-3.0-or-later
// The view as a PNG: twice the pixels of the screen, with title, legend and scale of heights.

const kScale = 2;
const kMargin = 18;
const kLine = 21;

function legend(pen, entries, right, dark) {
  pen.font = '14px system-ui, sans-serif';
  const width = Math.max(...entries.map(({ name }) => pen.measureText(name).width)) + 40;
  const height = entries.length * kLine + 14;
  const [x, y] = [right - width - kMargin, kMargin];
  pen.fillStyle = dark ? 'rgba(22,26,31,0.85)' : 'rgba(255,255,255,0.85)';
  pen.fillRect(x, y, width, height);
  entries.forEach(({ name, color }, i) => {
    const top = y + 8 + i * kLine;
    pen.fillStyle = color;
    pen.fillRect(x + 10, top + 2, 16, 14);
    pen.strokeStyle = 'rgba(0,0,0,0.35)';
    pen.strokeRect(x + 10, top + 2, 16, 14);
    pen.fillStyle = dark ? '#e6e9ed' : '#1c2126';
    pen.fillText(name, x + 34, top + 14);
  });
}

/** A blob of the picture. `entries`: { name, color } of the layers shown; `title`, `caption` above and below. */
export async function pictureOf(stage, { title, caption, entries, dark, background, labels }) {
  const [width, height] = stage.size;
  stage.pixels = kScale;
  stage.draw();
  const canvas = document.createElement('canvas');
  canvas.width = width * kScale;
  canvas.height = height * kScale;
  const pen = canvas.getContext('2d');
  pen.fillStyle = background;
  pen.fillRect(0, 0, canvas.width, canvas.height);
  pen.drawImage(stage.canvas, 0, 0, canvas.width, canvas.height);
  stage.pixels = null;
  stage.draw();
  pen.scale(kScale, kScale);
  const ink = dark ? '#e6e9ed' : '#1c2126';
  pen.fillStyle = ink;
  pen.font = '12px system-ui, sans-serif';
  for (const { text, x, y } of labels) pen.fillText(text, x, y);
  pen.font = '600 17px system-ui, sans-serif';
  pen.fillText(title, kMargin, kMargin + 14);
  pen.font = '13px system-ui, sans-serif';
  pen.fillText(caption, kMargin, height - kMargin);
  if (entries.length > 0) legend(pen, entries, width, dark);
  return new Promise((resolve) => canvas.toBlob(resolve, 'image/png'));
}

/** Hand a blob to the reader as a file. */
export function download(blob, name) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
