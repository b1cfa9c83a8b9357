// Takes off, flies to a place, and comes home:  npx tsx examples/goto.ts 'Copter 1' 47.3990 8.5460 20
import { CommandError } from '@dronemap/client';
import { connected } from './connected.js';

const [name = '', latitude = NaN, longitude = NaN, altitude = NaN] = process.argv
  .slice(2)
  .map((text, index) => (index === 0 ? text : Number(text))) as [string, number, number, number];
const CLOSE_DEGREES = 0.00002;

await using dronemap = await connected();
const drone = await dronemap.drone(name);
try {
  await drone.control(async ({ signal }) => {
    const step = async (request: Parameters<typeof drone.command>[0]): Promise<void> => {
      const command = await drone.command(request, { signal });
      console.log((await command.outcome({ signal, timeout: 60_000 })).summary);
    };
    await step({ type: 'setMode', mode: 'GUIDED' });
    await step({ type: 'arm' });
    await step({ type: 'takeOff', altitude });
    await drone.waitFor(({ position }) => (position?.altitudeAboveHome ?? 0) > altitude - 1, {
      signal,
      timeout: 120_000,
    });
    await step({ type: 'goTo', latitude, longitude, altitude });
    const there = await drone.waitFor(
      ({ position }) => isClose(position?.latitude, latitude) && isClose(position?.longitude, longitude),
      { signal, timeout: 300_000 },
    );
    console.log('It is there:', there.position);
  });
  await drone.waitFor(({ flight }) => flight === 'onGround', { timeout: 600_000 });
  console.log('It is home.');
} catch (thrown) {
  if (!(thrown instanceof CommandError)) {
    throw thrown;
  }
  console.error(`${thrown.name}: ${thrown.message}`);
  process.exitCode = 1;
}

function isClose(degrees: number | null | undefined, wanted: number): boolean {
  return typeof degrees === 'number' && Math.abs(degrees - wanted) < CLOSE_DEGREES;
}
