package org.dronemap.proxy.session;

import org.dronemap.core.drone.DroneKey;

/** Where a session comes from; {@code replay}: out of a recording, nothing is ever sent. */
record LinkLabel(DroneKey key, String transport, boolean replay) {}
