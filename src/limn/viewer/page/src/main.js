// SPDX-License-Identifier: BSD-3-Clause
// Reads the payload and starts the page. `limnViewer` is there for scripts, once it is ready.

import { App } from './app.js';
import { readPayload } from './payload.js';

const message = document.getElementById('message');

function fail(error) {
  message.classList.add('error');
  message.textContent = `The drawing cannot be shown: ${error.message ?? error}`;
}

async function start() {
  const payload = document.getElementById('payload');
  const scene = await readPayload(payload.textContent);
  payload.remove();
  window.limnViewer = new App(scene);
  message.textContent = '';
}

start().catch((error) => {
  fail(error);
  console.error(error);
});
