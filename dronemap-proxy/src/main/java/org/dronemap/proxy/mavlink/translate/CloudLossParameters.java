package org.dronemap.proxy.mavlink.translate;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.DoubleUnaryOperator;
import org.dronemap.core.drone.CloudLossAction;
import org.jspecify.annotations.Nullable;

/**
 * The parameters of one kind of vehicle that govern loss of the ground station, and the values to set.
 *
 * @param settings of the cloud's loss
 * @param height how high it flies home; null: it cannot be set
 * @param action what it does with these values, by the first of their names
 */
record CloudLossParameters(List<Setting> settings, ReturnHeightExchanges.@Nullable Setting height, Acting action) {
    /**
     * One parameter.
     *
     * @param names that firmware of different ages has for it
     * @param needed what does not have it cannot be set
     * @param wanted its value, given what its owner has set
     * @param bits that a mission may change as well
     */
    record Setting(List<String> names, boolean needed, DoubleUnaryOperator wanted, long bits) {
        static Setting needed(String name, DoubleUnaryOperator wanted) {
            return new Setting(List.of(name), true, wanted, 0);
        }

        static Setting ifThere(DoubleUnaryOperator wanted, String... names) {
            return new Setting(List.of(names), false, wanted, 0);
        }

        Setting withBits(long more) {
            return new Setting(names, needed, wanted, more);
        }

        String name() {
            return names.get(0);
        }
    }

    /** Says what a vehicle does by its values, and what its owner had. */
    interface Acting {
        CloudLossAction of(Map<String, Double> now, Map<String, Double> owners);
    }

    static DoubleUnaryOperator instead(double value, Double... stays) {
        return old -> List.of(stays).contains(old) ? value : old;
    }

    static OptionalDouble find(Map<String, Double> values, String name) {
        Double value = values.get(name);
        return value == null ? OptionalDouble.empty() : OptionalDouble.of(value);
    }

    List<List<String>> names() {
        List<List<String>> names = new ArrayList<>();
        settings.forEach(setting -> names.add(setting.names()));
        if (height != null) {
            names.add(height.words());
        }
        return names;
    }
}
