/**
 * What all handlers of HTTP share: answers, problems, headers, records of calls.
 *
 * <p>Enters: what holds for each request.
 *
 * <p>Never: a single feature.
 */
@NullMarked
package org.dronemap.ws.http;

import org.jspecify.annotations.NullMarked;
