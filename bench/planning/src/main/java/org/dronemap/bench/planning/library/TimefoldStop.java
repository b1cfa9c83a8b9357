package org.dronemap.bench.planning.library;

/** A waypoint as Timefold sees it. */
record TimefoldStop(int waypoint) {}
