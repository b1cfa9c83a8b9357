// @ts-check
/** What became of a command, in words. */

/**
 * @typedef {'busy' | 'succeeded' | 'refused' | 'failed' | 'timedOut' | 'superseded' | 'unknown' | 'notSent'} Result
 */

/** They have succeeded when the drone begins; the flight itself is seen on the map. */
const GOES_ON = new Set(['takeoff', 'goto', 'startMission', 'returnToLaunch', 'land']);
const LOOK =
  'Look at the drone before you press again. This page goes on asking the server what became of it.';

/** @param {string} sentence */
export function uncertainWords(sentence) {
  return `Not known whether it was carried out: ${sentence} ${LOOK}`;
}

/**
 * @param {string} operation
 * @param {{ result: Result, by?: string | null, reason?: string | null }} outcome as the server tells it
 * @returns {[Result, string]}
 */
export function outcomeOf(operation, { result, by, reason }) {
  const why = reason ? `: ${reason}` : '.';
  switch (result) {
    case 'succeeded':
      return [result, GOES_ON.has(operation) ? 'Succeeded: it has begun.' : 'Succeeded.'];
    case 'refused':
      return [result, `Refused by ${by === 'vehicle' ? 'the drone' : 'the server'}${why}`];
    case 'failed':
      return [result, `Failed${why}`];
    case 'timedOut':
      return [result, `Timed out${why}`];
    case 'superseded':
      return [result, `Replaced by a newer command${why}`];
    default:
      return [
        'unknown',
        `Not known whether it was carried out${why} Look at the drone before you press again.`,
      ];
  }
}
