package org.dronemap.ws.access;

import org.dronemap.core.access.Principal;

/** Who asks, through which face. */
public record Caller(Principal principal, String face) {}
