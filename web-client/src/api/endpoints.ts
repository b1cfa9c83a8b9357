/** A way in for vehicles with its state and counters. */
export interface Endpoint {
  id: string;
  url: string;
  transport: string;
  origin: 'configured' | 'added';
  addedBy: string | null;
  state: 'open' | 'connecting' | 'failed';
  reason: string | null;
  counts: {
    peers: number;
    framesIn: number;
    framesOut: number;
    lost: number;
    brokenBytes: number;
    droppedIn: number;
    droppedOut: number;
    throttled: number;
    refusedPeers: number;
    queue: number;
    kernelDrops: number | null;
  };
}

/** What one vehicle proves itself with on an encrypted link. */
export interface DtlsKey {
  identity: string;
  label: string;
  madeBy: string;
  connected: boolean;
  /** Only in the answer that made it. */
  secret: string | null;
}

/** By which one robot is known. */
export interface RobotKey {
  /** Of the drone that the robot is. */
  id: string;
  label: string;
  systemId: number;
  /** Whom the robot has to name where it names an owner; null: anybody. */
  owner: string | null;
  madeBy: string;
  connected: boolean;
  /** Only in the answer that made it. */
  key: string | null;
}

/** Which robot gets a key; with `drone` it replaces that robot's. */
export interface NewRobotKey {
  label?: string;
  systemId?: number;
  owner?: string;
  drone?: string;
}
