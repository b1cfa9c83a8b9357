import { cleanup, fireEvent, render, screen } from '@testing-library/svelte';
import { tick } from 'svelte';
import { afterEach, describe, expect, it, vi } from 'vitest';
import type { Role } from '../api/accounts';
import type { Figures, MissionRun, RunCalls } from '../api/runs';
import { STATION, Station } from '../state/station.svelte';
import { Runs } from '../state/runs.svelte';
import { aRun, aRunDrone as drone } from '../testing';
import RunPanel from './RunPanel.svelte';

function figures(longestSeconds: number, cost: number, unserved = 0): Figures {
  return { longestSeconds, cost, unserved };
}

afterEach(cleanup);

function runsWith(calls: Partial<RunCalls>): Runs {
  const runs = new Runs(calls as RunCalls);
  runs.apply(aRun());
  runs.show('r1');
  return runs;
}

describe('the runs that the page knows', () => {
  it('takes no older picture for the newest', () => {
    const runs = runsWith({});
    runs.apply(aRun({ journal: 9, state: 'stopping' }));
    runs.apply(aRun({ journal: 8 }));
    expect(runs.shown?.state).toBe('stopping');
    expect(runs.underWay).toHaveLength(1);
  });

  it('keeps what was marked when the run refuses it, and says why', async () => {
    const add = vi
      .fn()
      .mockRejectedValueOnce(new Error('Too far.'))
      .mockResolvedValue(aRun({ journal: 5 }));
    const runs = runsWith({ add });
    runs.selectTool('add');
    runs.mark({ latitude: 47.5, longitude: 8 });
    await runs.addMarks(30);
    expect(runs.problem).toBe('Too far.');
    expect(runs.marks).toHaveLength(1);
    await runs.addMarks(30);
    expect(add).toHaveBeenLastCalledWith('r1', [
      { latitude: 47.5, longitude: 8, altitude: 30, altitudeReference: 'home' },
    ]);
    expect([runs.problem, runs.tool, runs.marks.length]).toEqual([null, null, 0]);
  });

  it('moves the chosen waypoint to the last place that was marked', async () => {
    const move = vi.fn().mockResolvedValue(aRun());
    const runs = runsWith({ move });
    runs.choose('2');
    runs.selectTool('move');
    runs.mark({ latitude: 1, longitude: 2 });
    runs.mark({ latitude: 3, longitude: 4 });
    await runs.moveChosen();
    expect(move).toHaveBeenCalledWith('r1', '2', 3, 4);
  });

  it('puts a tool aside when the run takes no wishes any more', () => {
    const runs = runsWith({});
    runs.selectTool('add');
    runs.apply(aRun({ journal: 5, state: 'over' }));
    expect(runs.tool).toBeNull();
  });

  it('sends one wish at a time', async () => {
    let answer: (run: MissionRun) => void = () => undefined;
    const stop = vi.fn(() => new Promise<MissionRun>((resolve) => (answer = resolve)));
    const runs = runsWith({ stop });
    const first = runs.stop();
    await runs.stop();
    answer(aRun({ journal: 5, state: 'stopping' }));
    await first;
    expect(stop).toHaveBeenCalledTimes(1);
    expect(runs.busy).toBe(false);
  });
});

function panelFor(role: Role, run: MissionRun): Station {
  const station = new Station();
  station.connection.up();
  station.session = { name: 'olga', role, mustChangePassword: false, organisation: null };
  station.runs.apply(run);
  station.runs.show(run.id);
  render(RunPanel, { props: { run }, context: new Map([[STATION, station]]) });
  return station;
}

const PROPOSAL = {
  number: 2,
  at: '2026-01-01T12:00:00Z',
  words: 'Falcon has little battery left.',
  moved: [{ waypoint: '2', from: 'd1', to: 'd2' }],
  before: figures(60, 60),
  after: figures(70, 70),
};

describe('the panel of a run', () => {
  it('has no button for a viewer that a viewer cannot use', () => {
    const drones = [drone('d1', { stage: 'suspended', note: 'A pilot took over.' })];
    panelFor('viewer', aRun({ drones, proposal: PROPOSAL }));
    expect(screen.getByText('A pilot took over.')).toBeDefined();
    expect(screen.getByText('Falcon has little battery left.')).toBeDefined();
    const buttons = screen.getAllByRole('button').map((one) => one.textContent.trim());
    for (const never of [
      'End (all return)',
      'Add waypoints',
      'Change',
      'Fly the new plan',
      'Resume Falcon',
    ]) {
      expect(buttons).not.toContain(never);
    }
  });

  it('lets an operator answer, resume and end, and a supervisor hold', async () => {
    const drones = [drone('d1', { stage: 'suspended' })];
    const run = aRun({ drones, proposal: PROPOSAL });
    const station = panelFor('operator', run);
    const answer = vi.spyOn(station.rest.runs, 'answer').mockResolvedValue(run);
    const resume = vi.spyOn(station.rest.runs, 'resume').mockResolvedValue(run);
    await fireEvent.click(screen.getByRole('button', { name: 'Keep the old one' }));
    expect(answer).toHaveBeenCalledWith('r1', 2, false);
    await tick();
    await fireEvent.click(screen.getByRole('button', { name: 'Resume Falcon' }));
    expect(resume).toHaveBeenCalledWith('r1', 'd1');
    expect(screen.queryByRole('button', { name: 'Hold all drones' })).toBeNull();
    cleanup();
    panelFor('supervisor', run);
    expect(screen.getByRole('button', { name: 'Hold all drones' })).toBeDefined();
  });

  it('leaves pausing and ending within reach while places are marked', async () => {
    const station = panelFor('operator', aRun({}));
    station.runs.selectTool('add');
    await tick();
    for (const name of ['Stop marking', 'Pause', 'End (all return)']) {
      expect(screen.getByRole('button', { name })).toBeDefined();
    }
  });

  it('sends nothing while the cloud cannot be reached, and says so', async () => {
    const station = panelFor('operator', aRun({ proposal: PROPOSAL }));
    const answer = vi.spyOn(station.rest.runs, 'answer').mockResolvedValue(aRun());
    station.connection.down();
    await tick();
    expect(screen.getByText(/No connection to the cloud/)).toBeDefined();
    await fireEvent.click(screen.getByRole('button', { name: 'Fly the new plan' }));
    expect(answer).not.toHaveBeenCalled();
  });
});
