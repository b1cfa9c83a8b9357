package org.dronemap.ws.access;

import org.dronemap.core.access.Principal;

/** A principal and the face that it calls through. */
public record Caller(Principal principal, String face) {}
