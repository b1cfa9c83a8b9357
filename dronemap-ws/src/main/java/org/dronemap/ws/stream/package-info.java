/**
 * The stream: topics out, requests in, over WebSocket.
 *
 * <p>Enters: what holds for every topic or every request, and what is said of a connection itself.
 *
 * <p>Never: a topic, a request or a message of a feature: its room declares them.
 */
@NullMarked
package org.dronemap.ws.stream;

import org.jspecify.annotations.NullMarked;
