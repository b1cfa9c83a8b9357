import type { Timers } from '../stream/stream-client.js';

/** So many times as quick as the system's clock, so that a test waits for what happens and not for long. */
const TIMES = 3;

export const quickTimers: Timers = {
  now: () => performance.now() * TIMES,
  after: (milliseconds, action) => {
    const handle = setTimeout(action, milliseconds / TIMES);
    return () => clearTimeout(handle);
  },
};

/** How often a server has to say something that is heard by these timers. */
export const PING_MILLISECONDS = 1_000 / TIMES / 2;
