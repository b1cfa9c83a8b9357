package org.dronemap.ws.security;

import java.util.function.Supplier;

/**
 * The caller of a SOAP call that is carried out as a REST request within the server.
 *
 * @param face its name in records and in the command log
 * @param proved who proved to be the caller; refuses whoever did not. Asked once it is known that somebody must
 */
public record ForwardedCaller(String face, Supplier<AuthenticatedCaller> proved) {}
