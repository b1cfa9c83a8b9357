/**
 * Ends of processes of this server that nobody had stopped, and how carefully the next one starts.
 *
 * <p>Enters: what is counted of ends of this server.
 *
 * <p>Never: how a process is ended.
 */
@NullMarked
package org.dronemap.core.process;

import org.jspecify.annotations.NullMarked;
