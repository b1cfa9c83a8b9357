import { describe, expect, it } from 'vitest';
import { ViewState } from './view-state.svelte';

const HERE = { latitude: 47, longitude: 8 };

describe('view', () => {
  it('makes room for the map when a place is marked on it', () => {
    const view = new ViewState();
    view.select('d1');
    view.setTarget('d1', HERE);
    expect(view.sheet).toBe('low');
    expect(view.target).toEqual({ droneId: 'd1', ...HERE });
  });

  it('forgets the marked place with another choice', () => {
    const view = new ViewState();
    view.select('d1');
    view.setTarget('d1', HERE);
    view.select('d2');
    expect(view.target).toBeNull();
    expect(view.sheet).toBe('half');
  });
});
