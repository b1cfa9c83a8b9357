package org.dronemap.ws.security;

import java.util.function.Supplier;

/**
 * Another face than REST that a request came by, and who it says is calling.
 *
 * @param face its name in records and in the command log
 * @param proved who proved to be the caller; refuses whoever did not. Asked once it is known that somebody must
 */
public record ForwardedCaller(String face, Supplier<AuthenticatedCaller> proved) {}
