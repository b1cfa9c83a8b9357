import { describe, expect, it, vi } from 'vitest';
import { ScreenWakeLock } from './wake-lock.svelte';

class Sentinel extends EventTarget {
  readonly release = vi.fn(() => Promise.resolve());
}

class FakePage extends EventTarget {
  visibilityState: DocumentVisibilityState = 'visible';

  become(state: DocumentVisibilityState): void {
    this.visibilityState = state;
    this.dispatchEvent(new Event('visibilitychange'));
  }
}

const settled = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

function bench(): { page: FakePage; given: Sentinel[]; screen: ScreenWakeLock } {
  const page = new FakePage();
  const given: Sentinel[] = [];
  const request = (): Promise<WakeLockSentinel> => {
    const sentinel = new Sentinel();
    given.push(sentinel);
    return Promise.resolve(sentinel as unknown as WakeLockSentinel);
  };
  return { page, given, screen: new ScreenWakeLock({ request } as WakeLock, page as unknown as Document) };
}

describe('the screen', () => {
  it('is kept on, and asked for again when the page is seen again', async () => {
    const { page, given, screen } = bench();
    screen.start();
    await settled();
    expect(screen.state).toBe('held');

    page.become('hidden');
    given[0]?.dispatchEvent(new Event('release'));
    expect(screen.state).toBe('lost');
    page.become('visible');
    await settled();
    expect(screen.state).toBe('held');
    expect(given).toHaveLength(2);
  });

  it('may go off when nobody is followed any more', async () => {
    const { page, given, screen } = bench();
    screen.start();
    await settled();
    screen.stop();
    expect(given[0]?.release).toHaveBeenCalled();
    page.become('visible');
    await settled();
    expect(given).toHaveLength(1);
    expect(screen.state).toBe('off');
  });

  it('may go off when that was wished before the browser answered', async () => {
    const { given, screen } = bench();
    screen.start();
    screen.stop();
    await settled();
    expect(given[0]?.release).toHaveBeenCalled();
    expect(screen.state).toBe('off');
  });

  it('says that the browser will not, or cannot', async () => {
    const page = new FakePage() as unknown as Document;
    const lock = { request: () => Promise.reject(new DOMException('no', 'NotAllowedError')) };
    const saving = new ScreenWakeLock(lock as unknown as WakeLock, page);
    saving.start();
    await settled();
    expect(saving.state).toBe('refused');

    const old = new ScreenWakeLock(undefined, page);
    old.start();
    expect(old.state).toBe('unsupported');
  });
});
