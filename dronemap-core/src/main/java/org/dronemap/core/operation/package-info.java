/** The contract of operations: what the cloud conducts with drones over time, as pure state machines. */
@NullMarked
package org.dronemap.core.operation;

import org.jspecify.annotations.NullMarked;
