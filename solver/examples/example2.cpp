// Example 2 of the lecture, as printed there.
// clang-format off
#include "linearSolver.h"
class A2 : public implicitMatrix {
    public:
        virtual void matVecMult(double x[], double b[]) {
            b[0] = 2.0 * x[0] + 1.0 * x[1];
            b[1] = 1.0 * x[0] + 1.0 * x[1];
        }
};
int main(int argc, char **argv) {
    double x[2] = {0.0, 0.0};
    double b[2] = {3.0, 4.0};
    int steps = 100;
    implicitMatrix *a2 = new A2();
    double err = ConjGrad(2, a2, x, b, 1.0e-5, &steps);
    delete a2;
    printf("Solved in %i steps with error %f.\n", steps, err);
    printf("a2 * [%f %f]^T = [%f %f]^T.\n", x[0], x[1], b[0], b[1]);
    return 0;
}
