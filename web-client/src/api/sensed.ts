export type { DroneSensedNumbersView as SensedNumbers, SensedView as Sensed } from '@dronemap/client';
