package org.dronemap.sim.flight;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** The parameters of a simulated vehicle, by name and by index. Owned by its vehicle. */
public final class SimulatedParameters {
    /** A parameter with its MAVLink type number. */
    public record Parameter(String name, int type, double value) {}

    public static final int INT8 = 2;
    public static final int INT16 = 4;
    public static final int INT32 = 6;
    public static final int REAL32 = 9;

    private final List<Parameter> list = new ArrayList<>();

    public SimulatedParameters add(String name, int type, double value) {
        list.add(new Parameter(name, type, value));
        return this;
    }

    public int size() {
        return list.size();
    }

    public Parameter at(int index) {
        return list.get(index);
    }

    /** -1 when there is none of that name. */
    public int indexOf(String name) {
        for (int i = 0; i < list.size(); i++) {
            if (list.get(i).name().equals(name)) {
                return i;
            }
        }
        return -1;
    }

    public @Nullable Parameter find(String name) {
        int index = indexOf(name);
        return index < 0 ? null : list.get(index);
    }

    /** The value; throws IllegalArgumentException for a name that is not in the table. */
    public double value(String name) {
        Parameter found = find(name);
        if (found == null) {
            throw new IllegalArgumentException("this vehicle has no parameter " + name);
        }
        return found.value();
    }

    public boolean set(String name, double value) {
        int index = indexOf(name);
        if (index < 0) {
            return false;
        }
        Parameter old = list.get(index);
        list.set(index, new Parameter(name, old.type(), old.type() == REAL32 ? value : Math.rint(value)));
        return true;
    }
}
