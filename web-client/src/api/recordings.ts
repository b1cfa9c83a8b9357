/** A flight as it was recorded; what is null is not known yet. */
export interface Recording {
  id: string;
  drone: string;
  droneName: string;
  start: string;
  end: string | null;
  seconds: number | null;
  bytes: number;
  frames: number;
  drops: number;
  state: 'running' | 'complete' | 'incomplete';
  notice: string | null;
}

export interface RecordingPage {
  recordings: Recording[];
  room: { usedBytes: number; mostBytes: number; keepDays: number; removed: number; notice: string | null };
}
