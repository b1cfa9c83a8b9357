/**
 * Carries out what lines of JSON on the standard input ask for, by the client, and answers each with a line: for tests of
 * other languages. `{"do":"list"}`, `{"do":"rest","operation":…,"parameters":{…}}`,
 * `{"do":"command","drone":…,"body":{…}}`.
 */
import { createInterface } from 'node:readline';
import { WebSocket } from 'ws';
import { CommandError, Dronemap, Problem, Refused, type CommandRequest } from '../src/index.js';

interface Asked {
  do: 'list' | 'rest' | 'command';
  operation: string;
  parameters: Record<string, string>;
  drone: string;
  body: CommandRequest;
}

const { DRONEMAP_URL: url = '', DRONEMAP_KEY: key = '' } = process.env;
const dronemap = await Dronemap.connect({ url, key, WebSocket });

async function answered(asked: Asked): Promise<unknown> {
  switch (asked.do) {
    case 'list':
      return (await dronemap.drones()).map((drone) => drone.id);
    case 'rest': {
      const call = dronemap.rest[asked.operation as 'takeControl'];
      return call(asked.parameters as { id: string });
    }
    case 'command': {
      const drone = await dronemap.drone(asked.drone);
      const given = await drone.command(asked.body);
      const { outcome } = await given.outcome();
      return outcome;
    }
  }
}

function told(error: unknown): unknown {
  if (error instanceof CommandError) {
    const result = error.name.charAt(0).toLowerCase() + error.name.slice(1);
    return { result, by: error instanceof Refused ? error.by : null, code: error.code, reason: error.reason };
  }
  if (error instanceof Problem) {
    const { status, code, detail, field } = error;
    return { status, code, detail, field };
  }
  throw error;
}

for await (const line of createInterface({ input: process.stdin })) {
  const asked = JSON.parse(line) as Asked;
  const answer = await answered(asked).catch(told);
  process.stdout.write(`${JSON.stringify(answer ?? null)}\n`);
}
dronemap.close();
