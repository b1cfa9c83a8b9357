/**
 * The topic of the stream about plans, apart as the room of plans is full.
 *
 * <p>Enters: what clients of the stream are told of plans.
 *
 * <p>Never: what a plan is, and who may see it.
 */
@NullMarked
package org.dronemap.ws.plan.topic;

import org.jspecify.annotations.NullMarked;
