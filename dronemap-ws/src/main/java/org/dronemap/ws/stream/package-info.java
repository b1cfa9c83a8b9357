/**
 * The stream: topics out, requests in, over WebSocket.
 *
 * <p>Enters: a topic or a request.
 *
 * <p>Never: what a feature decides.
 */
@NullMarked
package org.dronemap.ws.stream;

import org.jspecify.annotations.NullMarked;
