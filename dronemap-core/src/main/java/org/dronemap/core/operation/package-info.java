/**
 * The contract of operations: what the cloud conducts with drones over time, as pure state machines.
 *
 * <p>Enters: what operations, and who conducts them, agree on.
 *
 * <p>Never: a single kind of operation.
 */
@NullMarked
package org.dronemap.core.operation;

import org.jspecify.annotations.NullMarked;
