/** A vehicle that nobody has let in; `claims` is the drone that it says it is without proving it. */
export interface WaitingVehicle {
  id: string;
  reason: 'unknown' | 'quarantined';
  claims: string | null;
  why: string;
  address: string;
  port: number;
  systemId: number;
  vehicle: string;
}
