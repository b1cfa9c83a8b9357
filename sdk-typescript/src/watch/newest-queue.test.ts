import { describe, expect, it } from 'vitest';
import { NewestQueue } from './newest-queue.js';

describe('a queue of what is newest', () => {
  it('hands out of each key the newest, in the order in which the keys came', async () => {
    const queue = new NewestQueue<number>(10);
    queue.push('a', 1);
    queue.push('b', 2);
    queue.push('a', 3);
    expect([await queue.next(), await queue.next()]).toEqual([{ value: 3 }, { value: 2 }]);
  });

  it('drops the oldest beyond its bound, and counts it', async () => {
    const queue = new NewestQueue<number>(2);
    [1, 2, 3, 4].forEach((one) => queue.push(one, one));
    expect(queue.takeLost()).toBe(2);
    expect(queue.takeLost()).toBe(0);
    expect(await queue.next()).toEqual({ value: 3 });
  });

  it('lets what waits be read before it ends', async () => {
    const queue = new NewestQueue<number>(2);
    queue.push('a', 1);
    queue.end(new Error('gone'));
    queue.push('b', 2);
    expect(await queue.next()).toEqual({ value: 1 });
    await expect(queue.next()).rejects.toThrow('gone');
    const quiet = new NewestQueue<number>(2);
    const next = quiet.next();
    quiet.end();
    expect(await next).toBeUndefined();
  });
});
