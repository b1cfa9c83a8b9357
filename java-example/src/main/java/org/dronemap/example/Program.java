package org.dronemap.example;

/** Runs a flight as a program: exit code 0, or 1 with the sentence that says why on the standard error. */
final class Program {
    interface Flight {
        void fly() throws FlightException;
    }

    private Program() {}

    static void run(Flight flight) {
        try {
            flight.fly();
        } catch (FlightException e) {
            System.err.println(e.getMessage());
            // What went wrong besides, when the drone was to be called home and control to be given back.
            for (Throwable besides : e.getSuppressed()) {
                System.err.println(besides.getMessage());
            }
            System.exit(1);
        }
    }
}
