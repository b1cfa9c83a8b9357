package org.dronemap.core.command;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.dronemap.core.drone.CloudLossAction;
import org.dronemap.core.parameter.OverriddenParameter;
import org.dronemap.core.parameter.ParameterValue;
import org.jspecify.annotations.Nullable;

/**
 * Is told the owner's parameter values before a vehicle adapter overrides them, so that they can be restored. Called on
 * the drone's lane; returns at once.
 */
public interface ParameterOverrideRecorder {
    /**
     * Cloud-loss parameters found on a vehicle, and the values that will be written.
     *
     * @param before what the vehicle does as it was found
     * @param after what it does with what is going to be written
     * @param returnMeters how high it flies home then; null: not known
     */
    record OverridePlan(
            CloudLossAction before,
            CloudLossAction after,
            List<OverriddenParameter> values,
            @Nullable Double returnMeters) {
        public OverridePlan {
            values = List.copyOf(values);
        }
    }

    /** How high it shall fly home, in m, as its owner has it at that height. */
    double returnMeters(double owners);

    /** Ends when the owner's values are durable; nothing is written before that, nor when it fails. */
    CompletableFuture<Void> keep(OverridePlan plan);

    /** What the vehicle shows is neither the owner's nor the cloud's; it stays as it is. */
    void skipped(List<ParameterValue> shown);
}
