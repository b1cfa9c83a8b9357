package org.dronemap.bench.planning;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.Collectors;

/**
 * {@code SOLVER PROBLEM-FILE SEED CPU-SECONDS THREADS WARM-UP-SECONDS}: one run. Without a warm-up the CPU counts from the
 * start of the process, else from the start of the search. Writes lines: {@code about}, {@code improved CPU VALUE},
 * {@code used CPU}, {@code tour WAYPOINT…} for each drone.
 */
public final class SolverMain {
    private static final int ARGUMENTS = 6;
    private static final int LARGEST_WARM_UP = 500;
    private static final double WARM_UP_ROUND_SECONDS = 1;

    private SolverMain() {}

    public static void main(String[] words) throws IOException {
        run(words, System.out);
        // Some libraries leave threads behind that would keep the process.
        System.exit(0);
    }

    static void run(String[] words, PrintStream out) throws IOException {
        if (words.length != ARGUMENTS) {
            throw new IllegalArgumentException("wants SOLVER PROBLEM-FILE SEED CPU-SECONDS THREADS WARM-UP-SECONDS");
        }
        Solver solver = Solvers.named(words[0]);
        long seed = Long.parseLong(words[2]);
        double seconds = Double.parseDouble(words[3]);
        int threads = Integer.parseInt(words[4]);
        double warmUp = Double.parseDouble(words[5]);
        TourProblem problem = TourProblemFile.read(Path.of(words[1]));
        warmUp(solver, problem.longest(), threads, warmUp);
        CpuBudget allowance = warmUp > 0 ? CpuBudget.fromNow(seconds) : CpuBudget.ofProcess(seconds);
        Convergence convergence = new Convergence(problem, allowance);
        int[][] orders = solver.solve(problem, new Solver.SearchOptions(seed, threads, allowance), convergence);
        double used = allowance.usedSeconds();
        convergence.accept(orders);
        print(out, solver, convergence, used);
    }

    private static void warmUp(Solver solver, boolean longest, int threads, double seconds) {
        RandomTourProblems problems = new RandomTourProblems(99);
        CpuBudget whole = CpuBudget.fromNow(seconds);
        for (long seed = 1; seconds > 0 && !whole.isSpent(); seed++) {
            CpuBudget round = CpuBudget.fromNow(WARM_UP_ROUND_SECONDS);
            solver.solve(problems.next(longest, LARGEST_WARM_UP), new Solver.SearchOptions(seed, threads, round), better -> {});
        }
    }

    private static void print(PrintStream out, Solver solver, Convergence convergence, double used) {
        out.println("about " + solver.about());
        for (Convergence.Point point : convergence.points()) {
            out.println("improved " + point.cpuSeconds() + " " + point.value());
        }
        out.println("used " + used);
        for (int[] order : convergence.best()) {
            out.println(
                    "tour " + Arrays.stream(order).mapToObj(Integer::toString).collect(Collectors.joining(" ")));
        }
    }
}
