package org.dronemap.bench.planning.library;

/** A waypoint as Timefold sees it. */
record Stop(int waypoint) {}
