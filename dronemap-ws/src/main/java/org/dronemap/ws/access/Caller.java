package org.dronemap.ws.access;

import org.dronemap.core.access.Principal;

/** An authenticated principal and the face (REST, SOAP or stream) that the call came through. */
public record Caller(Principal principal, String face) {}
